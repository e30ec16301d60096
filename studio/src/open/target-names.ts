import { hoistTargetNames } from 'furrow/internal'
import type { GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js'

/** Plugin for `GLTFLoader.register`. Like the command line, it also finds blendshape names where only some exporters write them. */
export function hoistNames({ json }: Pick<GLTFParser, 'json'>): GLTFLoaderPlugin {
  hoistTargetNames(json)
  return { name: 'FURROW_target_names' }
}
