import { PerspectiveCamera } from 'three'
import { afterEach, beforeEach, expect, it, vi } from 'vitest'
import type { StageTool } from '../../../studio/src/tools/stage-tool.ts'
import { ToolHost } from '../../../studio/src/tools/tool-host.ts'

/** Names of the tool's methods that were called, in order. */
let calls: string[]
let stage: EventTarget
let host: ToolHost
/** Promise that the tool must wait for, or null if it is ready. */
let waiting: Promise<unknown> | null
let isTaken: boolean

const tool: StageTool = {
  preparation: () => waiting,
  begin({ x }) {
    calls.push(`begin ${x}`)
    return isTaken
  },
  move: (pointers) => void calls.push(...pointers.map(({ x }) => `move ${x}`)),
  end: () => void calls.push('end'),
  cancel: () => void calls.push('cancel'),
}

beforeEach(() => {
  vi.stubGlobal('addEventListener', () => {})
  calls = []
  waiting = null
  isTaken = true
  stage = Object.assign(new EventTarget(), {
    classList: { toggle() {} },
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 100, height: 100 }),
    setPointerCapture() {},
    releasePointerCapture() {},
    focus() {},
  })
  host = new ToolHost(stage as HTMLElement, () => new PerspectiveCamera())
  host.choose(tool)
})
afterEach(() => vi.unstubAllGlobals())

function send(type: string, clientX: number): void {
  const event = new Event(type, { cancelable: true })
  const fields = { clientX, clientY: 50, pointerId: 1, pointerType: 'mouse', button: 0, isPrimary: true }
  stage.dispatchEvent(Object.assign(event, fields))
}

function draw(from: number, to: number): void {
  send('pointerdown', from)
  send('pointermove', to)
  send('pointerup', to)
}

it('passes the events of a pointer to the tool, from its start to its end', () => {
  draw(10, 20)
  expect(calls).toEqual(['begin 10', 'move 20', 'end'])
})

it('continues the gesture if the same tool is chosen again, and cancels it if another one is', () => {
  send('pointerdown', 10)
  host.choose(tool)
  send('pointermove', 20)
  host.choose(null)
  send('pointermove', 30)
  expect(calls).toEqual(['begin 10', 'move 20', 'cancel'])
})

it('queues pointer events while the tool waits, and passes them afterwards', async () => {
  let ready = () => {}
  waiting = new Promise<void>((resolve) => {
    ready = resolve
  })
  draw(10, 20)
  draw(30, 40)
  send('pointerdown', 50)
  expect(calls).toEqual([])
  ready()
  await waiting
  await Promise.resolve()
  send('pointermove', 60)
  expect(calls).toEqual(['begin 10', 'move 20', 'end', 'begin 30', 'move 40', 'end', 'begin 50', 'move 60'])
})

it('continues if the preparation of the tool fails, and releases a pointer that the tool refuses', async () => {
  waiting = Promise.reject(new Error('no skin'))
  isTaken = false
  draw(10, 20)
  await waiting.catch(() => {})
  await Promise.resolve()
  expect(calls).toEqual(['begin 10'])
})

it('drops queued events when another tool is selected', async () => {
  waiting = Promise.resolve()
  draw(10, 20)
  host.choose(null)
  await waiting
  await Promise.resolve()
  expect(calls).toEqual([])
})
