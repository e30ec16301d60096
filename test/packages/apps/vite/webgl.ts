import { WrinkleLoaderPlugin } from 'furrow/three'
import { WebGLRenderer } from 'three'
import type { GLTFParser } from 'three/addons/loaders/GLTFLoader.js'

export const renderer = new WebGLRenderer()
export const plugin = (parser: GLTFParser) => new WrinkleLoaderPlugin(parser)
