import type { VRM } from '@pixiv/three-vrm'
import { type Expression, FurrowError } from 'furrow'
import { vrmExpressions } from 'furrow/internal'
import { DeclaredWrinkles } from 'furrow/internal/three'
import { firstLine } from 'furrow-files'
import { LoadingManager, WebGLRenderer } from 'three'
import { type GLTF, GLTFLoader } from 'three/addons/loaders/GLTFLoader.js'
import type { FaceFile } from './face-file.ts'
import { findSkins, type SkinCandidate } from './skins.ts'
import { hoistNames } from './target-names.ts'
import { turnUpright } from './upright.ts'

export interface LoadedGltf {
  gltf: GLTF
  skins: SkinCandidate[]
  vrm: VRM | null
  /** Expressions of a VRM, as blendshape weights. */
  expressions: Expression[]
  /** Messages for the user, one sentence each. */
  notes: string[]
}

/** Made-up base URL. URLs that begin with it are replaced by URLs of the referenced files. */
const BASE = 'dropped:/'

/**
 * Loads a face with three.js. Downloads decoders and the VRM plugin only if the file needs them.
 *
 * @param name file name for errors.
 * @throws FurrowError if the file is damaged.
 */
export async function loadGltf(face: FaceFile, name: string): Promise<LoadedGltf> {
  const isVrm = usesExtension(face, 'VRMC_vrm') || usesExtension(face, 'VRM')
  try {
    try {
      return await load(face, isVrm)
    } catch (error) {
      if (!isVrm) throw error
      const loaded = await load(face, false)
      loaded.notes.push(`${name} is opened without its VRM features (${firstLine(error)})`)
      return loaded
    }
  } catch (error) {
    throw error instanceof FurrowError ? error : damagedError(name, error)
  }
}

async function load(face: FaceFile, isVrm: boolean): Promise<LoadedGltf> {
  const urls = new Map<string, string>()
  const manager = new LoadingManager().setURLModifier((url) => {
    const file = url.startsWith(BASE) && face.references.get(url.slice(BASE.length))
    if (!file) return url
    const address = urls.get(url) ?? URL.createObjectURL(file.file)
    urls.set(url, address)
    return address
  })
  const loader = new GLTFLoader(manager)
    .register(hoistNames)
    .register((parser) => new DeclaredWrinkles(parser))
  const decoders = await addDecoders(loader, manager, face)
  const vrm = isVrm ? await import('@pixiv/three-vrm') : null
  if (vrm) loader.register((parser) => new vrm.VRMLoaderPlugin(parser))
  try {
    const gltf = await loader.parseAsync(face.bytes.buffer, BASE)
    const loaded: VRM | null = gltf.userData.vrm ?? null
    // VRM 0 avatars look along -Z, others along +Z.
    if (loaded) vrm?.VRMUtils.rotateVRM0(loaded)
    else turnUpright(gltf)
    const notes: string[] = []
    const skins = await findSkins(gltf, (problem) => notes.push(problem))
    return { gltf, skins, vrm: loaded, expressions: vrmExpressions(gltf.parser.json), notes }
  } finally {
    for (const url of urls.values()) URL.revokeObjectURL(url)
    for (const decoder of decoders) decoder.dispose()
  }
}

async function addDecoders(
  loader: GLTFLoader,
  manager: LoadingManager,
  face: FaceFile,
): Promise<{ dispose(): unknown }[]> {
  const added: { dispose(): unknown }[] = []
  if (usesExtension(face, 'EXT_meshopt_compression') || usesExtension(face, 'KHR_meshopt_compression')) {
    const { MeshoptDecoder } = await import('three/addons/libs/meshopt_decoder.module.js')
    loader.setMeshoptDecoder(MeshoptDecoder)
  }
  if (usesExtension(face, 'KHR_draco_mesh_compression')) {
    const { DRACOLoader } = await import('three/addons/loaders/DRACOLoader.js')
    const draco = new DRACOLoader(manager)
    loader.setDRACOLoader(draco)
    added.push(draco)
  }
  if (usesExtension(face, 'KHR_texture_basisu')) {
    const { KTX2Loader } = await import('three/addons/loaders/KTX2Loader.js')
    // The stage has no renderer yet, so ask a temporary one for the texture formats of the GPU. WebGPU supports these formats, too.
    const renderer = new WebGLRenderer()
    const ktx2 = new KTX2Loader(manager).detectSupport(renderer)
    renderer.dispose()
    renderer.forceContextLoss()
    loader.setKTX2Loader(ktx2)
    added.push(ktx2)
  }
  return added
}

/** Whether a file uses an extension. Some files store an extension in `extensions` but do not list it in `extensionsUsed`. */
function usesExtension({ json }: FaceFile, extension: string): boolean {
  return Boolean(json.extensionsUsed?.includes(extension) || json.extensions?.[extension])
}

function damagedError(name: string, error: unknown): FurrowError {
  return new FurrowError(
    {
      code: 'unreadable',
      who: 'Studio',
      problem: `${name} cannot be loaded`,
      value: firstLine(error),
      limit: 'a whole glTF 2.0 file (.glb, .vrm, .gltf)',
      remedy: 'export it again',
    },
    { cause: error },
  )
}
