/**
 * GLSL ES 3.0 and WGSL, as far as the formulas of the layers are written differently in them. Their expressions are the same where vectors
 * are made by name, and no component is assigned.
 */
export interface Dialect {
  readonly isWgsl: boolean
  readonly int: string
  readonly float: string
  readonly vec2: string
  readonly vec3: string
  readonly vec4: string
  /** A variable of a function. */
  local(type: string, name: string, value: string): string
  /** A variable of the whole shader, of each fragment. */
  global(type: string, name: string, value: string): string
  /** A function; its parameters as pairs of type and name, and null for no result. */
  declare(
    result: string | null,
    name: string,
    parameters: readonly (readonly [string, string])[],
    body: string,
  ): string
  /** The value of a uniform of the material. */
  uniform(name: string): string
  /** What the vertex shader passes on. */
  passed(name: string): string
  derivatives(value: string): readonly [string, string]
  /** Declares an array of maps. */
  arrayOfMaps(name: string): string
  /** Declares a texture whose mipmaps are not read. */
  texture(name: string): string
  /** A sample whose level of detail the sampler finds; in control flow that pixels share only. */
  sampleArray(name: string, uv: string, slice: string): string
  /** A sample by derivatives. */
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
