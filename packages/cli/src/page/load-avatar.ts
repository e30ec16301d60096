import { MToonMaterialLoaderPlugin, VRMLoaderPlugin } from '@pixiv/three-vrm'
import { MToonNodeMaterial } from '@pixiv/three-vrm/nodes'
import { DeclaredWrinkles } from 'furrow/internal/three'
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js'
import { GLTFLoader, type GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { KTX2Loader } from 'three/addons/loaders/KTX2Loader.js'
import { type Face, loadFace } from '../../../../stage/face.ts'
import { isWebGL } from '../../../../stage/light.ts'
import type { Renderer } from '../../../../stage/stage.ts'

const VRM = ['VRM', 'VRMC_vrm', 'VRMC_materials_mtoon']

/**
 * Loads a face. Supports Draco, KTX 2 and VRM. If three-vrm rejects a VRM, loads the file as glTF without VRM features
 * and warns.
 *
 * @throws Error like `loadFace`.
 */
export async function loadAvatar(url: string, skin: string | undefined, renderer: Renderer): Promise<Face> {
  let isVrm = false
  const loader = loaderFor(renderer)
    .register((parser) => new DeclaredWrinkles(parser))
    .register((parser) => {
      isVrm = VRM.some((name) => parser.json.extensionsUsed?.includes(name) || parser.json.extensions?.[name])
      return isVrm ? vrmPlugin(parser, renderer) : { name: 'no VRM' }
    })
  try {
    return await loadFace(url, skin, loader)
  } catch (error) {
    if (!isVrm) throw error
    const face = await loadFace(url, skin, loaderFor(renderer))
    console.warn(
      `furrow render: ${url} is drawn as plain glTF, without VRM features (${(error as Error).message})`,
    )
    return face
  }
}

function loaderFor(renderer: Renderer): GLTFLoader {
  return new GLTFLoader()
    .setDRACOLoader(new DRACOLoader())
    .setKTX2Loader(new KTX2Loader().detectSupport(renderer))
}

function vrmPlugin(parser: GLTFParser, renderer: Renderer): VRMLoaderPlugin {
  if (isWebGL(renderer)) return new VRMLoaderPlugin(parser)
  const materialType = MToonNodeMaterial as never
  return new VRMLoaderPlugin(parser, {
    mtoonMaterialPlugin: new MToonMaterialLoaderPlugin(parser, { materialType }),
  })
}
