import { WrinkleLoaderPlugin } from 'furrow/webgpu'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'
import { WebGPURenderer } from 'three/webgpu'

export const renderer = new WebGPURenderer()
export const plugin = (parser: GLTFParser) => new WrinkleLoaderPlugin(parser)
