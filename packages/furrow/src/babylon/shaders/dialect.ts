/**
 * Generates statements and declarations in GLSL ES 3.0 or WGSL, so that one generator writes shaders in both languages. Expressions are
 * the same in both languages if they take type names from the dialect. Code must not assign to swizzles such as `v.xy`, because not all
 * browsers allow this in WGSL.
 */
export interface Dialect {
  readonly isWgsl: boolean
  readonly int: string
  readonly float: string
  readonly vec2: string
  readonly vec3: string
  readonly vec4: string
  local(type: string, name: string, value: string): string
  /** Declares a global variable, which has a separate value for each fragment. */
  global(type: string, name: string, value: string): string
  /** Declares a function. Parameters are pairs of type and name. `result` is null for a function without a result. */
  declare(
    result: string | null,
    name: string,
    parameters: readonly (readonly [string, string])[],
    body: string,
  ): string
  /** Reads a uniform of the material. */
  uniform(name: string): string
  /** Reads a varying in the fragment shader. */
  passed(name: string): string
  derivatives(value: string): readonly [string, string]
  /** Declares a texture array with its sampler. */
  arrayOfMaps(name: string): string
  /** Declares a 2D texture with its sampler. The texture has no mipmaps. */
  texture(name: string): string
  /** Samples a texture array with implicit derivatives. WGSL allows this in uniform control flow only. */
  sampleArray(name: string, uv: string, slice: string): string
  /** Samples a texture array with the given derivatives. */
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
