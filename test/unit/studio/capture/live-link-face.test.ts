import { describe, expect, it } from 'vitest'
import { readLiveLinkFace } from '../../../../studio/src/capture/live-link-face.ts'
import { readCapture } from '../../../../studio/src/capture/read-capture.ts'

const NAMES = ['EyeBlinkLeft', 'JawOpen', 'BrowInnerUp', 'TongueOut']
const ROTATIONS = ['HeadYaw', 'HeadPitch', 'HeadRoll', 'LeftEyeYaw', 'RightEyeRoll']
const HEADER = ['Timecode', 'BlendShapeCount', ...NAMES, ...ROTATIONS]

const row = (timecode: string, ...weights: number[]) => [
  timecode,
  String(NAMES.length + ROTATIONS.length),
  ...NAMES.map((_, i) => String(weights[i] ?? 0)),
  ...ROTATIONS.map(() => '-0.3'),
]
const TAKE = [
  HEADER,
  row('23:59:59:58.250', 0.1, 0.2),
  row('23:59:59:59.250', 0.3, 0.4),
  row('00:00:00:00.250', 0.5),
]

const file = (text: BlobPart, name = 'take.csv') => new File([text], name)
const textOf = (rows: readonly (readonly string[])[], separator = ',', end = '\n') =>
  rows.map((cells) => cells.join(separator) + end).join('')
const read = (rows: readonly (readonly string[])[]) => readLiveLinkFace(file(textOf(rows)))
const refused = (text: BlobPart) =>
  readLiveLinkFace(file(text)).then(
    () => 'it is read',
    ({ name, message }: Error) => `${name}: ${message}`,
  )

describe('a Live Link Face take', () => {
  it('is read as blendshape weights over time, also past midnight, and without rotations', async () => {
    const { name, times, weights } = await read(TAKE)
    expect(name).toBe('take')
    expect([...times]).toEqual([0, Math.fround(1 / 60), Math.fround(2 / 60)])
    expect([...weights.keys()]).toEqual(NAMES)
    expect([...weights.get('EyeBlinkLeft')!]).toEqual([0.1, 0.3, 0.5].map(Math.fround))
  })

  it.each([
    ['Windows ends its lines', textOf(TAKE, ',', '\r\n')],
    ['old Macs end their lines', textOf(TAKE, ',', '\r')],
    ['a byte order mark and blank lines are round it', `\uFEFF${textOf(TAKE)}\n\n`],
    ['it has semicolons', textOf(TAKE, ';')],
    ['it has semicolons and decimal commas', textOf(TAKE, ';').replace(/(\d)\.(\d+)(?=;|\n)/g, '$1,$2')],
    ['it has tabs', textOf(TAKE, '\t')],
    ['its cells are quoted', textOf(TAKE.map((cells) => cells.map((cell) => `"${cell}"`)))],
    ['its last row is cut off', `${textOf(TAKE)}00:00:00:01.250,9,0.`],
  ])('is read the same with %s', async (_, text) => {
    // With commas between the columns, a fraction of a frame cannot have a decimal comma.
    const restored = text.replace(/:(\d\d),(\d+)/g, ':$1.$2')
    expect(await readLiveLinkFace(file(restored))).toEqual(await read(TAKE))
  })

  it('may lack some columns, and have the others in another order', async () => {
    const short = TAKE.map((cells) => [cells[3], cells[0]])
    const { weights } = await read(short)
    expect([...weights]).toEqual([['JawOpen', (await read(TAKE)).weights.get('JawOpen')]])
  })

  it.each([
    [30, 29],
    [25, 24],
    [24, 23],
    [60, 59],
    [50, 48],
  ])('has the rate of its timecode: %i frames per second', async (rate, last) => {
    const { times } = await read([HEADER, row('10:00:00:00'), row(`10:00:00:${last}`), row('10:00:01:00')])
    expect(times[1]).toBeCloseTo(last / rate, 5)
    expect(times[2]).toBe(1)
  })

  it('skips frames that are not later than the frame before', async () => {
    const { times, weights } = await read([
      HEADER,
      row('10:00:00:00', 0.1),
      row('10:00:00:00', 0.2),
      row('10:00:00:02', 0.3),
    ])
    expect(times).toHaveLength(2)
    expect([...weights.get('EyeBlinkLeft')!]).toEqual([0.1, 0.3].map(Math.fround))
  })

  it('has its weights limited to 0..1', async () => {
    const { weights } = await read([HEADER, row('10:00:00:00', -0.5), row('10:00:00:01', 1.5)])
    expect([...weights.get('EyeBlinkLeft')!]).toEqual([0, 1])
  })

  it('is recognised among the other tables of its folder', async () => {
    const log = file('1,2\n3,4\n', 'frame_log.csv')
    const calibration = file(textOf(TAKE.slice(0, 3)), 'take_cal.csv')
    expect((await readCapture([log, calibration, file(textOf(TAKE))])).name).toBe('take')
    await expect(readCapture([log])).rejects.toThrow('frame_log.csv cannot be played')
  })
})

describe('a skipped cell', () => {
  const take = (...rows: string[]) => readLiveLinkFace(file(`Timecode,JawOpen,JawLeft\n${rows.join('\n')}\n`))

  it('gets a weight interpolated between its neighbours, or the nearest one at either end', async () => {
    const { weights } = await take(
      '1:0:0:0,,',
      '1:0:0:1,0.2,',
      '1:0:0:2,,',
      '1:0:0:3, ,',
      '1:0:0:4,0.8,',
      '1:0:0:5,,',
    )
    expect([...weights.get('JawOpen')!].map((value) => Number(value.toFixed(3)))).toEqual([
      0.2, 0.2, 0.4, 0.6, 0.8, 0.8,
    ])
    // A column without any weight is left out.
    expect([...weights.keys()]).toEqual(['JawOpen'])
  })

  it.each([
    ['in the middle', ['1:0:0:0', '', '1:0:0:2']],
    ['at the beginning', ['', '1:0:0:1', '1:0:0:2']],
    ['at the end', ['1:0:0:0', '1:0:0:1', '17']],
    ['everywhere', ['0', '1', '2']],
    ['over midnight', ['23:59:59:59', '', '0:0:0:1']],
  ])('of a timecode is interpolated between its neighbours: %s', async (_, timecodes) => {
    const { times } = await take(...timecodes.map((timecode) => `${timecode},0.5,0`))
    expect([...times].map((time) => Math.round(60 * time))).toEqual([0, 1, 2])
  })
})

describe('a take that cannot be played is refused with a message of one line:', () => {
  const header = `${HEADER.join(',')}\n`
  it.each([
    ['nothing', '', 'its first row has no Timecode, allowed: a CSV of Live Link Face'],
    ['a table without names', '0.1,0.2\n0.3,0.4\n', 'its first row has no Timecode'],
    ['bytes', new Uint8Array(100_000), 'its first row has no Timecode'],
    ['names alone', header, 'it has no motion, got 0, allowed: 2 frames or more'],
    ['one frame', header + textOf([row('10:00:00:00')]), 'it has no motion, got 1'],
    ['no blendshapes', 'Timecode,HeadYaw\n10:00:00:00,1\n', 'it has no blendshapes'],
    ['no number', textOf([HEADER, row('10:00:00:00', Number.NaN)]), 'frame 1, EyeBlinkLeft, got "NaN"'],
    ['an infinite one', textOf([HEADER, row('1:0:0:0'), row('1:0:0:1', 0, Infinity)]), 'frame 2, JawOpen'],
    [
      'another time',
      `Timecode,JawOpen\n0.25,1\n`,
      'frame 1, invalid timecode, got "0.25", allowed: HH:MM:SS:FF',
    ],
    ['a torn row', textOf([HEADER, ['10:00:00:00', '9'], row('10:00:00:01')]), 'frame 1, cells are missing'],
  ])('%s', async (_, content, problem) => {
    const message = await refused(content)
    expect(message).toContain(`FurrowError: Studio: take.csv cannot be played: ${problem}`)
    expect(message).toMatch(/; export the take from Live Link Face again, as CSV$/)
    expect(message).not.toContain('\n')
  })

  it('a file of 100 MB that is not a take, once its first megabytes are read', async () => {
    let read = 0
    const endless = new ReadableStream<Uint8Array>({
      pull(controller) {
        read++
        controller.enqueue(new Uint8Array(2 ** 20).fill(0x61))
      },
    })
    const large = Object.assign(file('', 'large.csv'), { stream: () => endless })
    await expect(readLiveLinkFace(large)).rejects.toThrow('large.csv cannot be played: its first row')
    expect(read).toBeLessThan(5)
  })

  it('a file of 200 MB, without reading it', async () => {
    const large = file('', 'large.csv')
    Object.defineProperty(large, 'size', { value: 200 * 2 ** 20 })
    await expect(readLiveLinkFace(large)).rejects.toThrow('it is too large, got "200 MB", allowed: 128 MB')
  })

  it('a take of an hour', async () => {
    const lines = Array.from({ length: 120_001 }, (_, i) => `10:00:00:${i % 60},0`)
    const long = file(`Timecode,JawOpen\n${lines.join('\n')}\n`)
    await expect(readLiveLinkFace(long)).rejects.toThrow('it is too long, allowed: 120000 frames')
  })
})
