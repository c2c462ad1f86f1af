// The numbers of a scene, as every back end receives them. Only vec4 members, so that std140,
// CUDA, OpenCL C and C++ agree on the layout. PackScene fills it in double precision.
//
// Spaces: "voxel" is the index space of the texels with its origin in the middle of the box that
// holds the field, so one unit is one voxel edge on every axis; "texture" is [0, 1]^3; "data" has
// the grid's own lengths, in which opacity is given per unit distance, as in VTK; "world" adds the
// prop's transform and is the space of lights, relative to the middle of the box.
#define LIGHT_LIMIT 8
#define CLIP_PLANE_LIMIT 8

SCENE_BLOCK_BEGIN
  vec4 rayOrigin;       // xyz: voxel point at the middle of the viewport on the reference plane
  vec4 rayOriginX;      // xyz: change of that point per unit of normalized device x
  vec4 rayOriginY;      // xyz: the same per unit of y
  vec4 rayDirection;    // xyz: ray direction at the middle of the viewport, not normalized
  vec4 rayDirectionX;   // xyz: its change per unit of normalized device x (zero when parallel)
  vec4 rayDirectionY;   // xyz: the same per unit of y
  vec4 viewDepth;       // xyz: gradient of the view depth in voxel space; w: depth of the origin
  vec4 depthRange;      // x, y: near and far view depth; z: 1 for a parallel camera; w: how
                        // often rayDirection goes into a unit of view depth
  vec4 depthProjection; // x, y: the two numbers that turn window depth into view depth
  vec4 viewport;        // x, y: lower left pixel; z, w: 2 / width, 2 / height
  vec4 rectangle;       // x, y: lower left pixel of all that the box covers, to which textures of
                        // a technique's own are relative; z, w: its size
  vec4 boxHalf;         // xyz: half the size of the box in voxels
  vec4 heldLow;         // xyz: lowest corner of the part of the box whose voxels this process has
  vec4 occupiedLow;     // xyz: lowest corner of the box round all that can be seen, in voxels
  vec4 occupiedHigh;    // xyz: its highest corner
  vec4 shareSlab;       // xyz: what is drawn lies where this times a place, in voxels, is between the
                        // w of the next two
  vec4 brickLow;        // xyz: lowest corner of the brick that is drawn, in voxels
  vec4 brickHigh;       // xyz: its highest corner
  vec4 cells;           // xyz: the last macrocell of each axis; w: macrocells per voxel
  vec4 textureScale;    // xyz: texture coordinate per voxel
  vec4 textureOffset;   // xyz: texture coordinate of the middle of the box
  vec4 textureSize;     // xyz: texels per axis
  vec4 dataX;           // xyz: first row of the voxel-to-data matrix, in which opacity has its unit
  vec4 dataY;           // xyz: second row
  vec4 dataZ;           // xyz: third row
  vec4 worldX;          // xyz: first row of the voxel-to-world matrix, in which lights stand
  vec4 worldY;          // xyz: second row
  vec4 worldZ;          // xyz: third row
  vec4 normalX;         // xyz: first row of its inverse transpose, which turns gradients
  vec4 normalY;         // xyz: second row
  vec4 normalZ;         // xyz: third row
  vec4 clipX;           // first row of the voxel-to-clip matrix
  vec4 clipY;           // second row
  vec4 clipZ;           // third row
  vec4 clipW;           // fourth row
  vec4 cropX;           // dot(xyz, voxel) + w is in [0, 1] inside the crop box, first axis
  vec4 cropY;           // second axis
  vec4 cropZ;           // third axis
  vec4 cropRegions;     // x, y: flags of the first 14 and the other 13 of the 27 crop regions
  vec4 clipPlaneCount;  // x: number of clip planes in use
  vec4 classification;  // x, y: scale and offset from a stored value to a table coordinate; z, w:
                        // the same for the component that gives the colour, where there are two
  vec4 oneColor;        // xyz: colour of all that can be seen, where that is one
  vec4 segments;        // x, y: the same for a coordinate of the pre-integrated table
  vec4 prefix;          // x, y: scale and offset from a stored value to a cell of the table of prefix
                        // integrals; z: its last cell; w: cells below which values are close
  vec4 prefixUnits;     // extinction, x: times colour, y: alone, per unit of that table; z: units
                        // below which the colour is taken from the ends of a step
  vec4 extremes;        // x, y: stored values at which Minimum and Maximum stop; z: 1 / their span;
                        // w: 1 / the samples that have the last colour where samples are shown
  vec4 gradientX;       // xyz: first row of the matrix from differences to gradients in data units
  vec4 gradientY;       // xyz: second row
  vec4 gradientZ;       // xyz: third row
  vec4 gradientOpacity; // x, y: scale and offset from gradient magnitude to its table coordinate
  vec4 sampling;        // x: step in voxels, which for Segment, with a sample in its middle, is two
                        // of the user's; y: opacity at which a ray stops; z: the distance over
                        // which opacity is given, in data units; w: seed of the jitter
  vec4 material;        // ambient, diffuse, specular, specular power
  vec4 lightCount;      // x: number of lights in use; y: weight of lighting per stored difference
  vec4 lightPosition[LIGHT_LIMIT]; // w 0: xyz is the direction to the light; w 1: its position
  vec4 lightColor[LIGHT_LIMIT];    // rgb times intensity
  vec4 clipPlane[CLIP_PLANE_LIMIT]; // dot(xyz, voxel) + w is positive where the volume is kept
SCENE_BLOCK_END
