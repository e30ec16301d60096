// Uses `furrow/gltf` with only glTF-Transform installed.
import { Document, WebIO } from '@gltf-transform/core'
import { FurrowWrinkleMaps, type MaterialWrinkles } from 'furrow/gltf'

const document = new Document()
const extension = document.createExtension(FurrowWrinkleMaps)
const texture = document.createTexture().setImage(new Uint8Array(8)).setMimeType('image/png')
const layer = extension.createLayer('expression').setTexture('normalTexture', texture)
const area = extension.createArea('nose').setTexture(texture)
const wrinkles = extension.createMaterialWrinkles().addLayer(layer).addArea(area)
document.createBuffer()
document.createMaterial('skin').setExtension(FurrowWrinkleMaps.EXTENSION_NAME, wrinkles)

const io = new WebIO().registerExtensions([FurrowWrinkleMaps])
const read = await io.readBinary(await io.writeBinary(document))
const [material] = read.getRoot().listMaterials()
const found = material?.getExtension<MaterialWrinkles>(FurrowWrinkleMaps.EXTENSION_NAME)
console.info(JSON.stringify({ areas: found?.listAreas().map((one) => one.getName()) }))
