// Component-wise arithmetic for CUDA's built-in float vectors, which come without operators.
#define VECTOR_FUNC __device__ inline

VECTOR_FUNC float3 operator+(float3 a, float3 b) { return make_float3(a.x + b.x, a.y + b.y, a.z + b.z); }
VECTOR_FUNC float3 operator-(float3 a, float3 b) { return make_float3(a.x - b.x, a.y - b.y, a.z - b.z); }
VECTOR_FUNC float3 operator*(float3 a, float3 b) { return make_float3(a.x * b.x, a.y * b.y, a.z * b.z); }
VECTOR_FUNC float3 operator*(float s, float3 a) { return make_float3(s * a.x, s * a.y, s * a.z); }
VECTOR_FUNC float3 operator/(float3 a, float s) { return make_float3(a.x / s, a.y / s, a.z / s); }
VECTOR_FUNC float3 operator-(float3 a) { return make_float3(-a.x, -a.y, -a.z); }
VECTOR_FUNC float4 operator+(float4 a, float4 b)
{
  return make_float4(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);
}
VECTOR_FUNC float4 operator-(float4 a, float4 b)
{
  return make_float4(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);
}
VECTOR_FUNC float4 operator*(float s, float4 a)
{
  return make_float4(s * a.x, s * a.y, s * a.z, s * a.w);
}
VECTOR_FUNC float dot(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
VECTOR_FUNC float length(float3 a) { return sqrtf(dot(a, a)); }
VECTOR_FUNC float3 normalize(float3 a) { return (1.0f / length(a)) * a; }
VECTOR_FUNC float3 max(float3 a, float3 b)
{
  return make_float3(fmaxf(a.x, b.x), fmaxf(a.y, b.y), fmaxf(a.z, b.z));
}
VECTOR_FUNC float3 min(float3 a, float3 b)
{
  return make_float3(fminf(a.x, b.x), fminf(a.y, b.y), fminf(a.z, b.z));
}
