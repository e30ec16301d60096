import { WrinkleLoaderPlugin } from 'furrow/webgpu'
import { refusal } from './refused.js'

await refusal(WrinkleLoaderPlugin)
