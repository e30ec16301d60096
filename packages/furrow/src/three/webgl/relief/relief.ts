import {
  GLSL3,
  type Material,
  MeshDepthMaterial,
  MeshDistanceMaterial,
  NoBlending,
  REVISION,
  RGBADepthPacking,
  ShaderMaterial,
  Vector4,
  type WebGLProgramParametersWithUniforms,
  type WebGLRenderer,
} from 'three'
import { FurrowError } from '../../../core/error.ts'
import { COARSE_WIDTH, type CoarseParts } from '../../relief/coarse-pass.ts'
import { type CreateRelief, ReliefControl } from '../../relief/relief-control.ts'
import { onsetLevels, type ReliefInputs } from '../../relief/relief-inputs.ts'
import type { ReliefParts } from '../../relief/relief-parts.ts'
import { NEWEST_THREE } from '../../three-version.ts'
import { quadMaterials } from '../influence/influence-quads.ts'
import { valueLayers } from '../mixing/value-layers.ts'
import { MAIN, replace, replaceChunk } from '../patch/shader-text.ts'
import { mapUniforms, onsetUniforms } from '../uniforms.ts'
import { type ReliefVariant, reliefFunctions } from './relief-surface.ts'

/** Vertex shader of `CoarsePass`. Chunks of three.js deform each vertex; the result is drawn to the texel of the vertex. */
const COARSE_VERTEX = /* glsl */ `
#include <common>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
uniform highp sampler2D furrowRing;
uniform int furrowFirst;
uniform int furrowRows;
out vec4 vFurrowPosition;
out vec4 vFurrowDirections;

vec2 furrowOctahedral(vec3 direction) {
  vec3 v = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
  return v.z < 0.0 ? (1.0 - abs(v.yx)) * vec2(v.x < 0.0 ? -1.0 : 1.0, v.y < 0.0 ? -1.0 : 1.0) : v.xy;
}

void main() {
  #include <beginnormal_vertex>
  #include <morphnormal_vertex>
  #include <skinbase_vertex>
  #include <skinnormal_vertex>
  #include <begin_vertex>
  #include <morphtarget_vertex>
  #include <skinning_vertex>
  int i = furrowFirst + gl_VertexID;
  ivec2 texel = ivec2(i % ${COARSE_WIDTH}, i / ${COARSE_WIDTH});
  vFurrowPosition = vec4(transformed, texelFetch(furrowRing, texel, 0).r);
  vFurrowDirections = vec4(furrowOctahedral(objectNormal), 0.0, 0.0);
  #ifdef USE_TANGENT
    vFurrowDirections.zw = furrowOctahedral(objectTangent);
  #endif
  vec2 centre = (vec2(texel) + 0.5) / vec2(${COARSE_WIDTH}.0, float(furrowRows));
  gl_Position = vec4(centre * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 1.0;
}
`

const COARSE_FRAGMENT = /* glsl */ `
in vec4 vFurrowPosition;
in vec4 vFurrowDirections;
layout(location = 0) out vec4 position;
layout(location = 1) out vec4 directions;

void main() {
  position = vFurrowPosition;
  directions = vFurrowDirections;
}
`

const coarseMaterial: CoarseParts['coarseMaterial'] = (ring, first, rows, hasTangents) =>
  new ShaderMaterial({
    name: 'furrow coarse',
    glslVersion: GLSL3,
    vertexShader: COARSE_VERTEX,
    fragmentShader: COARSE_FRAGMENT,
    uniforms: { furrowRing: { value: ring }, furrowFirst: { value: first }, furrowRows: { value: rows } },
    defines: hasTangents ? { USE_TANGENT: '' } : {},
    blending: NoBlending,
    depthTest: false,
    depthWrite: false,
  })

/** Patches the GLSL of a material to displace dense geometries. Keeps earlier patches. */
const patch: ReliefParts['patch'] = (material, relief, inputs, instances) => {
  const { onBeforeCompile, customProgramCacheKey } = material
  const { layers, channel } = relief.heights
  const { onset } = valueLayers(inputs.textures.values)
  const variant: ReliefVariant = {
    heights: layers,
    channel,
    isInstanced: instances !== null,
    ...(onset && { onset: { ...onset, levels: onsetLevels(inputs, relief) } }),
  }
  const uniforms = { ...mapUniforms(inputs), ...reliefUniforms(relief), ...onsetUniforms(inputs) }
  material.onBeforeCompile = (shader: WebGLProgramParametersWithUniforms, renderer: WebGLRenderer) => {
    onBeforeCompile.call(material, shader, renderer)
    try {
      shader.vertexShader = reliefVertex(shader.vertexShader, reliefFunctions(variant))
    } catch (error) {
      relief.refuse(unpatchable((error as Error).message))
      return
    }
    shader.uniforms = { ...shader.uniforms, ...uniforms }
  }
  const key = JSON.stringify(variant)
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} relief ${key}`
  return () => Object.assign(material, { onBeforeCompile, customProgramCacheKey })
}

function unpatchable(missing: string): FurrowError {
  return new FurrowError({
    code: 'unsupported',
    who: 'Wrinkles',
    problem: `the shader cannot be patched for relief in three.js r${REVISION}: missing text`,
    value: missing,
    limit: `the built-in lit materials of three.js up to r${NEWEST_THREE}`,
    remedy: 'use a built-in lit material, or the composed mode',
  })
}

function reliefVertex(vertex: string, functions: string): string {
  const declared = replace(
    vertex,
    MAIN,
    `${functions}\n${MAIN}\nif (furrowIsDense()) furrowReadDirections();`,
  )
  const turned = replaceChunk(
    declared,
    'beginnormal_vertex',
    (chunk) => `${chunk}
if (furrowIsDense()) {
  objectNormal = furrowShadingNormal();
  #ifdef USE_TANGENT
    objectTangent = furrowShadingTangent();
  #endif
}
`,
  )
  const moved = replaceChunk(
    turned,
    'begin_vertex',
    (chunk) => `${chunk}\nif (furrowIsDense()) transformed = furrowSurface();\n`,
  )
  if (moved === turned) throw new Error('begin_vertex')
  return moved
}

function reliefUniforms({ heights, coarse, unitsPerMetre, amount }: ReliefInputs) {
  return {
    furrowCoarsePositions: { value: coarse.positions },
    furrowCoarseDirections: { value: coarse.directions },
    furrowHeights: { value: heights.texture },
    furrowUnitsPerMetre: { value: unitsPerMetre },
    furrowAmount: amount,
  }
}

/** Adds patched shadow materials to a relief mesh, because three.js draws shadows with separate materials. */
const addShadowMaterials: ReliefParts['addShadowMaterials'] = (dense, mesh, relief, inputs, instances) => {
  const materials: Material[] = [
    mesh.customDepthMaterial?.clone() ?? new MeshDepthMaterial({ depthPacking: RGBADepthPacking }),
    mesh.customDistanceMaterial?.clone() ?? new MeshDistanceMaterial(),
  ]
  for (const material of materials) patch(material, relief, inputs, instances)
  ;[dense.customDepthMaterial, dense.customDistanceMaterial] = materials
  return () => {
    for (const material of materials) material.dispose()
  }
}

/** Clones and patches an outline material. Other meshes, e.g. copies of an avatar, may use the original. Clone and original share uniforms. */
const outlineMaterial: ReliefParts['outlineMaterial'] = (outline, relief, inputs, instances) => {
  const { uniforms } = outline as Partial<ShaderMaterial>
  if (!uniforms) return null
  const copy = Object.assign(outline.clone(), { uniforms })
  patch(copy, relief, inputs, instances)
  return copy
}

const viewport = new Vector4()

/**
 * Calls `draw`, and then restores the viewport. three.js draws several views of a shadow to one render target, and sets the viewport only
 * once per view.
 */
const duringShadow: ReliefParts['duringShadow'] = (renderer, draw) => {
  const { state } = renderer as WebGLRenderer
  const context = (renderer as WebGLRenderer).getContext()
  viewport.fromArray(context.getParameter(context.VIEWPORT))
  draw()
  state.viewport(viewport)
}

const PARTS: ReliefParts = {
  coarseMaterial,
  hasContents: quadMaterials.hasContents,
  patch,
  addShadowMaterials,
  outlineMaterial,
  duringShadow,
}

export const createRelief: CreateRelief = (face, mode) => new ReliefControl(face, PARTS, mode)
