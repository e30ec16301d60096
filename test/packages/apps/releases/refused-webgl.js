import { WrinkleLoaderPlugin } from 'furrow/three'
import { refusal } from './refused.js'

await refusal(WrinkleLoaderPlugin)
