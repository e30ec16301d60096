/** Packets of face trackers, built byte by byte from their published layouts. */

/** Bytes of a text in ASCII. */
const text = (value: string) => [...Buffer.from(value, 'ascii')]

function int32(value: number): number[] {
  return [(value >>> 24) & 255, (value >>> 16) & 255, (value >>> 8) & 255, value & 255]
}

function float32(value: number): number[] {
  const bytes = Buffer.alloc(4)
  bytes.writeFloatBE(value)
  return [...bytes]
}

/**
 * Packet of Live Link Face, see https://github.com/JimWest/PyLiveLinkFace (`pylivelinkface.py`, `encode`). The fields are: version,
 * identifier of the device, name of the subject, frame number, part of a frame, frame rate as a fraction, number of values, values.
 */
export function liveLinkPacket(
  values: readonly number[],
  { version = 6, count = values.length } = {},
): Buffer {
  const device = '12345678-1234-1234-1234-123456789abc'
  const name = 'iPhone'
  return Buffer.from([
    version,
    ...int32(device.length),
    ...text(device),
    ...int32(name.length),
    ...text(name),
    ...int32(1000),
    ...float32(0.5),
    ...int32(60),
    ...int32(1),
    count,
    ...values.flatMap(float32),
  ])
}

/** 61 values of Live Link Face, all zero except the given ones. The indices are those of `FaceBlendShape` in `pylivelinkface.py`. */
export function liveLinkValues(values: Record<number, number>): number[] {
  return Array.from({ length: 61 }, (_, i) => values[i] ?? 0)
}

/** A string of Open Sound Control 1.0: ended by at least one zero, and padded to four bytes. */
function oscString(value: string): number[] {
  return [...text(value), ...new Array<number>(4 - (value.length % 4)).fill(0)]
}

/** Message of Open Sound Control 1.0 (https://opensoundcontrol.stanford.edu/spec-1_0.html). */
export function oscMessage(address: string, ...values: (string | number)[]): Buffer {
  const types = values.map((value) => (typeof value === 'string' ? 's' : 'f')).join('')
  const bytes = values.map((value) => (typeof value === 'string' ? oscString(value) : float32(value)))
  return Buffer.from([...oscString(address), ...oscString(`,${types}`), ...bytes.flat()])
}

/** Bundle of Open Sound Control 1.0, with the time tag "immediately". */
export function oscBundle(...elements: Buffer[]): Buffer {
  const parts = elements.flatMap((element) => [...int32(element.length), ...element])
  return Buffer.from([...oscString('#bundle'), 0, 0, 0, 0, 0, 0, 0, 1, ...parts])
}

/** Frame of VMC, see https://protocol.vmc.info/marionette-spec.html. */
export function vmcMessages(scores: Record<string, number>): Buffer[] {
  return [
    oscMessage('/VMC/Ext/T', 12.5),
    ...Object.entries(scores).map(([name, value]) => oscMessage('/VMC/Ext/Blend/Val', name, value)),
    oscMessage('/VMC/Ext/Blend/Apply'),
  ]
}

/** Text of iFacialMocap, see https://www.ifacialmocap.com/for-developer/. */
export function ifacialmocapPacket(scores: Record<string, number>, separator = '-'): Buffer {
  const shapes = Object.entries(scores).map(([name, value]) => `${name}${separator}${value}|`)
  return Buffer.from(
    `${shapes.join('')}=head#-21.488958,-6.038993,-6.6019735,-0.030653415,-0.10287084,-0.6584072|rightEye#6.02,2.44,0.25|leftEye#6.03,-1.66,-0.17|`,
  )
}

/** Size of a face in a packet of OpenSeeFace, and offsets in it, counted from `readFromPacket` in `Unity/OpenSee.cs`. */
export const OPEN_SEE = { size: 1785, found: 28, features: 1729 } as const

/**
 * Packet of OpenSeeFace with one face, see https://github.com/emilianavt/OpenSeeFace (`Unity/OpenSee.cs`, commit bc74658).
 *
 * @param features 14 features in the order of `OpenSeeFeatures`.
 */
export function openSeePacket(features: readonly number[], isFound = true): Buffer {
  const packet = Buffer.alloc(OPEN_SEE.size)
  packet.writeDoubleLE(12.5, 0)
  packet.writeInt32LE(0, 8)
  packet.writeFloatLE(640, 12)
  packet.writeFloatLE(480, 16)
  packet.writeUInt8(isFound ? 1 : 0, OPEN_SEE.found)
  for (const [i, value] of features.entries()) packet.writeFloatLE(value, OPEN_SEE.features + 4 * i)
  return packet
}
