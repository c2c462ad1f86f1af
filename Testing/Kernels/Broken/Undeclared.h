// Shared text with a fault on line 6, behind a feature; TestKernels.cxx expects it to be found.
#if WITH_CROP
FUNC real undeclared(real value)
{
  real known = value;
  return known * notDeclared;
}
#endif
