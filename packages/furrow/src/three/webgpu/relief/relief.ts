import type { Material } from 'three'
import {
  int,
  ivec2,
  normalLocal,
  outputStruct,
  positionLocal,
  tangentLocal,
  textureLoad,
  varying,
  vec2,
  vec4,
  vertexIndex,
} from 'three/tsl'
import type { NodeMaterial } from 'three/webgpu'
import { COARSE_WIDTH, type CoarseParts } from '../../relief/coarse-pass.ts'
import { type CreateRelief, ReliefControl } from '../../relief/relief-control.ts'
import type { ReliefParts } from '../../relief/relief-parts.ts'
import { quadMaterial, quadMaterials } from '../influence/influence-quads.ts'
import { typed } from '../node.ts'
import { toOctahedron } from './octahedron.ts'
import { reliefPosition } from './relief-surface.ts'

/** Creates the material of `CoarsePass`, which draws each vertex to one texel. three.js applies blendshapes and skinning before `vertexNode`. */
const coarseMaterial: CoarseParts['coarseMaterial'] = (ring, first, rows, hasTangents) => {
  const i = int(vertexIndex).add(first)
  const texel = ivec2(i.mod(int(COARSE_WIDTH)), i.div(int(COARSE_WIDTH)))
  const next = textureLoad(ring, texel).x
  const material = quadMaterial(
    'coarse',
    outputStruct(
      varying(vec4(positionLocal, next)),
      varying(vec4(toOctahedron(normalLocal), hasTangents ? toOctahedron(tangentLocal) : vec2(0))),
    ) as never,
  )
  // Row 0 of a render target is at y = 1, because three.js flips render targets on both backends.
  const centre = vec2(texel).add(0.5).div(vec2(COARSE_WIDTH, rows))
  material.vertexNode = vec4(centre.mul(vec2(2, -2)).add(vec2(-1, 1)), 0, 1)
  return material
}

type Patched = Material & Partial<Pick<NodeMaterial, 'positionNode'>>

let patchCount = 0

/**
 * Sets the `positionNode` of a material. This also works on a material that is not a node material, because the renderer draws it with a node
 * material to which it copies all properties.
 */
const patch: ReliefParts['patch'] = (material: Patched, relief, inputs, instances) => {
  const { positionNode, customProgramCacheKey } = material
  const hadOwn = Object.hasOwn(material, 'positionNode')
  const variant = `relief ${patchCount++}`
  material.positionNode = reliefPosition(relief, inputs, instances, positionNode ? typed(positionNode) : null)
  material.customProgramCacheKey = () => `${customProgramCacheKey.call(material)} ${variant}`
  return () => {
    if (hadOwn) material.positionNode = positionNode!
    else Reflect.deleteProperty(material, 'positionNode')
    material.customProgramCacheKey = customProgramCacheKey
  }
}

const PARTS: ReliefParts = {
  coarseMaterial,
  hasContents: quadMaterials.hasContents,
  patch,
  // No shadow materials are needed, because shadows use the `positionNode` of the material.
  addShadowMaterials: () => () => {},
  // Outlines are unsupported: a node material reads its own width and colour, so a clone would ignore changes of the original outline.
  outlineMaterial: () => null,
  duringShadow: (_renderer, draw) => draw(),
}

export const createRelief: CreateRelief = (face, mode) => new ReliefControl(face, PARTS, mode)
