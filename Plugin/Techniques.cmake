# The list of techniques: one row each, and the only existing file that a new technique edits.
# The order is the order in ParaView's menus. CONTRIBUTING.md tells how to add one.
volumebench_technique(single-pass CLASS SinglePass LABEL "Volume Single Pass"
  SETTINGS InteractiveFrameTime MemoryBudget ErrorTarget Skipping TerminationThreshold RaySetUp Jitter JitterSeed)
volumebench_technique(multi-pass CLASS MultiPass LABEL "Volume Multi Pass"
  SETTINGS InteractiveFrameTime MemoryBudget ErrorTarget Skipping TerminationThreshold Jitter JitterSeed)
volumebench_technique(compute CLASS ComputeRayCast LABEL "Volume Compute"
  SETTINGS InteractiveFrameTime MemoryBudget ErrorTarget Skipping TerminationThreshold RaySetUp Jitter JitterSeed WorkGroupShape
    VoxelOrder)
volumebench_technique(opencl CLASS OpenClRayCast LABEL "Volume OpenCL"
  SETTINGS InteractiveFrameTime MemoryBudget Skipping TerminationThreshold Jitter JitterSeed WorkGroupShape
    VoxelOrder OpenclDevice OpenclStorage)
volumebench_technique(cuda CLASS CudaRayCast LABEL "Volume CUDA" FOLDER CUDA
  REQUIRES VOLUMEBENCH_CUDA_FOUND "CUDA's toolkit"
  SETTINGS InteractiveFrameTime MemoryBudget Skipping TerminationThreshold Jitter JitterSeed WorkGroupShape VoxelOrder PictureTransfer)
volumebench_technique(slices CLASS Slices LABEL "Volume Slices"
  SETTINGS InteractiveFrameTime MemoryBudget Skipping Jitter JitterSeed SliceExtent SliceOrder SliceTarget)
volumebench_technique(slices-threaded CLASS SlicesThreaded LABEL "Volume Slices Threaded"
  SETTINGS InteractiveFrameTime MemoryBudget Skipping Jitter JitterSeed SliceExtent SliceOrder SliceTarget SliceThreads)
volumebench_technique(reference CLASS Reference LABEL "Volume Reference"
  WITHOUT StepVoxels Integrator)
