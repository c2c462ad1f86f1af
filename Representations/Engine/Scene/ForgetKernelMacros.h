// Undefines the macros that a dialect and the shared kernel text leave behind, for who instantiates
// the text more than once. It has no include guard.
#undef FUNC
#undef STRUCT
#undef PRECISE
#undef SCENE_PARAM
#undef SCENE
#undef REAL
#undef TO_REAL
#undef TO_INT
#undef TO_UINT
#undef VEC3
#undef VEC4
#undef SCENE_BLOCK_BEGIN
#undef SCENE_BLOCK_END
#undef LIGHT_LIMIT
#undef CLIP_PLANE_LIMIT
#undef CELL_MARGIN
#undef EXTREME_OF_ENDS
#undef BETWEEN_ENDS
#undef BORDERS_MOVE
#undef GRADED_STEPS
#undef GRADED_LENGTHS
#undef SAMPLES_OF_STEP
#undef PREFIX_ENTRY
#undef RAMP_ENTRIES
#undef FIRST_RAMP_PLACES
