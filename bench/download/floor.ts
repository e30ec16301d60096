/**
 * The floor of the download: as little as shows the shipped face's wrinkles as the library does, while its blendshapes move, on
 * `WebGLRenderer`. For one layer of details, areas that are added up, and drivers that add up blendshapes, as that file has them. Whatever is
 * wrong with a file breaks it, and nothing can be set, asked or cloned. `npm run size -- --floor` builds and weighs it.
 */
import {
  Camera,
  DataArrayTexture,
  GLSL3,
  HalfFloatType,
  type Material,
  Mesh,
  type MeshStandardMaterial,
  PlaneGeometry,
  ShaderChunk,
  ShaderMaterial,
  type Texture,
  type WebGLRenderer,
  WebGLRenderTarget,
} from 'three'
import type { GLTF, GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { type Curve, curveAt } from '../../packages/furrow/src/drivers/curve.ts'

/** A texture of the file. */
export interface FloorTexture {
  index: number
  amplitude: number
}

/** The extension's JSON, as far as it is read. */
interface FloorMaps {
  layers: { normalTexture: FloorTexture; occlusionTexture: FloorTexture; bloodTexture?: FloorTexture }[]
  areas: { name: string; texture: FloorTexture; channel?: number }[]
  drivers: { area: string; targets: { name: string; weight: number }[]; curve: Curve }[]
}

/** A layer's other maps. */
export interface FloorChannels {
  textureOf(layer: FloorMaps['layers'][number]): FloorTexture
  /** The fragment shader with what mixes them. */
  edit(shader: string): string
}

/** The wrinkles of a material, which all its faces share. */
interface FloorSet {
  maps: FloorMaps
  normals: Texture
  /** The layer's other maps, if any. */
  values: Texture | undefined
  areas: DataArrayTexture
  /** Index of each area's activation: that of its image, times 4, and its channel. */
  slots: Map<string, number>
}

/** A plugin of `GLTFLoader`. */
export function floorPlugin(channels?: FloorChannels): (parser: GLTFParser) => GLTFLoaderPlugin {
  return (parser) => ({
    name: 'FURROW_wrinkle_maps',
    async afterRoot({ scene }: GLTF) {
      const sets = new Map<FloorMaps, Promise<FloorSet>>()
      const meshes: Mesh[] = []
      scene.traverse((object) => object instanceof Mesh && meshes.push(object))
      for (const mesh of meshes) {
        const { materials = -1 } = parser.associations.get(mesh.material as Material) ?? {}
        const maps = parser.json.materials[materials]?.extensions?.FURROW_wrinkle_maps
        if (!maps) continue
        if (!sets.has(maps)) sets.set(maps, readSet(parser, maps, channels))
        addFace(mesh, await sets.get(maps)!, channels)
      }
    },
  })
}

async function readSet(parser: GLTFParser, maps: FloorMaps, channels?: FloorChannels): Promise<FloorSet> {
  const load = ({ index }: FloorTexture): Promise<Texture> => parser.getDependency('texture', index)
  const [layer] = maps.layers
  const textures = [...new Set(maps.areas.map(({ texture }) => texture.index))]
  const [normals, values, ...images] = await Promise.all([
    load(layer.normalTexture),
    channels && load(channels.textureOf(layer)),
    ...textures.map((index) => parser.getDependency('texture', index)),
  ])
  const slots = maps.areas.map(
    ({ name, texture, channel = 0 }) => [name, 4 * textures.indexOf(texture.index) + channel] as const,
  )
  return { maps, normals, values, areas: arrayOf(images), slots: new Map(slots) }
}

/** The images as slices, read from one canvas. */
function arrayOf(textures: Texture<ImageBitmap>[]): DataArrayTexture {
  const { width, height } = textures[0].image
  const all = height * textures.length
  const context = new OffscreenCanvas(width, all).getContext('2d')!
  for (const [i, { image }] of textures.entries()) context.drawImage(image, 0, i * height)
  const { buffer } = context.getImageData(0, 0, width, all).data
  const array = new DataArrayTexture(new Uint8Array(buffer), width, height, textures.length)
  array.needsUpdate = true
  return array
}

function addFace(mesh: Mesh, { maps, normals, values, areas, slots }: FloorSet, channels?: FloorChannels) {
  const { width, height, depth } = areas.image
  const target = new WebGLRenderTarget(width, height, { type: HalfFloatType, depthBuffer: false })
  const activations = new Float32Array(4 * depth)
  const pass = new Mesh(new PlaneGeometry(2, 2), passOf(areas, activations))
  pass.frustumCulled = false
  const camera = new Camera()
  const drawn = new Float32Array(activations)
  mesh.onBeforeRender = (renderer: WebGLRenderer) => {
    activations.fill(0)
    for (const { area, targets, curve } of maps.drivers) {
      let sum = 0
      for (const { name, weight } of targets) {
        sum += weight * mesh.morphTargetInfluences![mesh.morphTargetDictionary![name]]
      }
      activations[slots.get(area)!] += curveAt(curve, sum)
    }
    if (activations.every((activation, i) => activation === drawn[i])) return
    drawn.set(activations)
    const before = renderer.getRenderTarget()
    renderer.setRenderTarget(target)
    renderer.render(pass, camera)
    renderer.setRenderTarget(before)
  }
  // Another face with the same material has its own influence map.
  const material = (mesh.material as MeshStandardMaterial).clone()
  mesh.material = material
  const uniforms = {
    floorInfluence: { value: target.texture },
    floorNormals: { value: normals },
    floorValues: { value: values },
    floorAmplitude: { value: maps.layers[0].bloodTexture?.amplitude },
  }
  material.onBeforeCompile = (shader) => {
    Object.assign(shader.uniforms, uniforms)
    const { fragmentShader } = shader
    shader.fragmentShader = mixNormals(channels ? channels.edit(fragmentShader) : fragmentShader)
  }
  material.addEventListener('dispose', () => {
    for (const used of [target, pass.geometry, pass.material, normals, values, areas]) used?.dispose()
  })
}

/** What draws an influence map: the areas times their activations, added up. */
function passOf(areas: DataArrayTexture, activations: Float32Array): ShaderMaterial {
  const { depth } = areas.image
  return new ShaderMaterial({
    glslVersion: GLSL3,
    depthTest: false,
    uniforms: { areas: { value: areas }, activations: { value: activations } },
    vertexShader: 'void main() { gl_Position = vec4(position, 1.0); }',
    fragmentShader: /* glsl */ `
uniform highp sampler2DArray areas;
uniform vec4 activations[${depth}];
out vec4 influence;
void main() {
  for (int i = 0; i < ${depth}; i++)
    influence += dot(texelFetch(areas, ivec3(gl_FragCoord.xy, i), 0), activations[i]);
}`,
  })
}

/** Reoriented normal mapping, as the library does it, before the material lights its normals. */
function mixNormals(shader: string): string {
  const normals = ShaderChunk.normal_fragment_maps.replace(
    'mapN.xy *= normalScale;',
    /* glsl */ `
vec3 wrinkle = texture2D(floorNormals, vNormalMapUv).xyz * 2.0 - 1.0;
float size = length(mapN);
vec3 t = vec3(mapN.xy, mapN.z + size);
vec3 r = vec3(wrinkle.xy * (-influence / wrinkle.z), 1.0);
mapN = t * dot(t, r) - r * (size * t.z);
mapN.xy *= normalScale;`,
  )
  return shader.replace('#include <normal_fragment_maps>', normals).replace(
    'void main() {',
    /* glsl */ `
uniform sampler2D floorInfluence;
uniform sampler2D floorNormals;
void main() {
float influence = min(texture2D(floorInfluence, vNormalMapUv).r, 1.0);`,
  )
}
