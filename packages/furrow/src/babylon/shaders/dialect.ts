/**
 * Syntax differences between GLSL ES 3.0 and WGSL. Expressions are identical if vectors are constructed by type name and no component is
 * assigned.
 */
export interface Dialect {
  readonly isWgsl: boolean
  readonly int: string
  readonly float: string
  readonly vec2: string
  readonly vec3: string
  readonly vec4: string
  /** Declares a local variable. */
  local(type: string, name: string, value: string): string
  /** Declares a global variable, per fragment. */
  global(type: string, name: string, value: string): string
  /** Declares a function. Parameters are pairs of type and name; a null result is void. */
  declare(
    result: string | null,
    name: string,
    parameters: readonly (readonly [string, string])[],
    body: string,
  ): string
  /** Value of a material uniform. */
  uniform(name: string): string
  /** Value of a varying, in the fragment shader. */
  passed(name: string): string
  derivatives(value: string): readonly [string, string]
  /** Declares a texture array. */
  arrayOfMaps(name: string): string
  /** Declares a texture without mipmaps. */
  texture(name: string): string
  /** Sample with implicit level of detail; in uniform control flow only. */
  sampleArray(name: string, uv: string, slice: string): string
  /** Sample with explicit derivatives. */
  sampleArrayBy(name: string, uv: string, slice: string, dx: string, dy: string): string
  sampleTexture(name: string, uv: string): string
}

export const GLSL: Dialect = {
  isWgsl: false,
  int: 'int',
  float: 'float',
  vec2: 'vec2',
  vec3: 'vec3',
  vec4: 'vec4',
  local: (type, name, value) => `${type} ${name} = ${value};`,
  global: (type, name, value) => `${type} ${name} = ${value};`,
  declare: (result, name, parameters, body) =>
    `${result ?? 'void'} ${name}(${parameters.map((words) => words.join(' ')).join(', ')}) {\n${body}\n}`,
  uniform: (name) => name,
  passed: (name) => name,
  derivatives: (value) => [`dFdx(${value})`, `dFdy(${value})`],
  arrayOfMaps: (name) => `uniform highp sampler2DArray ${name};`,
  texture: (name) => `uniform highp sampler2D ${name};`,
  sampleArray: (name, uv, slice) => `texture(${name}, vec3(${uv}, float(${slice})))`,
  sampleArrayBy: (name, uv, slice, dx, dy) =>
    `textureGrad(${name}, vec3(${uv}, float(${slice})), ${dx}, ${dy})`,
  sampleTexture: (name, uv) => `textureLod(${name}, ${uv}, 0.0)`,
}

export const WGSL: Dialect = {
  isWgsl: true,
  int: 'i32',
  float: 'f32',
  vec2: 'vec2f',
  vec3: 'vec3f',
  vec4: 'vec4f',
  local: (type, name, value) => `var ${name}: ${type} = ${value};`,
  global: (type, name, value) => `var<private> ${name}: ${type} = ${value};`,
  declare: (result, name, parameters, body) =>
    `fn ${name}(${parameters.map(([type, word]) => `${word}: ${type}`).join(', ')}) ${result ? `-> ${result} ` : ''}{\n${body}\n}`,
  uniform: (name) => `uniforms.${name}`,
  passed: (name) => `fragmentInputs.${name}`,
  derivatives: (value) => [`dpdx(${value})`, `dpdy(${value})`],
  arrayOfMaps: (name) => `var ${name}Sampler: sampler;\nvar ${name}: texture_2d_array<f32>;`,
  texture: (name) => `var ${name}Sampler: sampler;\nvar ${name}: texture_2d<f32>;`,
  sampleArray: (name, uv, slice) => `textureSample(${name}, ${name}Sampler, ${uv}, ${slice})`,
  sampleArrayBy: (name, uv, slice, dx, dy) =>
    `textureSampleGrad(${name}, ${name}Sampler, ${uv}, ${slice}, ${dx}, ${dy})`,
  sampleTexture: (name, uv) => `textureSampleLevel(${name}, ${name}Sampler, ${uv}, 0.0)`,
}
