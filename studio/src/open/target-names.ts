import { hoistTargetNames } from 'furrow/internal'
import type { GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'

/** Lets three.js find names of blendshapes where only some exporters write them, as the commands do. For `GLTFLoader.register`. */
export function hoistNames({ json }: Pick<GLTFParser, 'json'>): GLTFLoaderPlugin {
  hoistTargetNames(json)
  return { name: 'FURROW_target_names' }
}
