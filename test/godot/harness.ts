import { afterAll, beforeAll, beforeEach } from 'vitest'
import { command, type GodotEngine, type Json, startGodot } from './start-godot.ts'

/** Width and height of pictures, pixels. */
export const SIZE = 32

export type { Json }

/** Picture as drawn: RGBA, 8 bits, sRGB, rows from the top. */
export type Picture = Uint8Array

/** Scene in Godot with copies of a glTF file. */
export interface GodotScene {
  /** Number of faces with wrinkles. */
  readonly faces: number
  /** Calls a method of `project/test_scene.gd`. */
  call<T>(method: string, args?: Json): Promise<T>
  /** Calls a method that returns a picture. */
  draw(method: string, args?: Json): Promise<Picture>
  close(): Promise<void>
}

export interface GodotHarness {
  /** Loads a file into a new scene. Returns the engine's error if it cannot load the file. */
  open(bytes: ArrayBuffer, copies?: number): Promise<GodotScene | { error: string }>
  /** Errors and warnings of the engine since the test began, each with the line of its source. */
  messages: string[]
}

/** Starts Godot once for all tests in the current file. */
export function godot(): GodotHarness {
  const harness = { messages: [] as string[] } as GodotHarness
  let engine: GodotEngine | undefined
  beforeAll(async () => {
    engine = await startGodot((text) => harness.messages.push(text))
    harness.open = openScene
  })
  beforeEach(() => void harness.messages.splice(0))
  afterAll(() => engine?.requestQuit())
  return harness
}

let scenes = 0

async function openScene(bytes: ArrayBuffer, copies = 1): Promise<GodotScene | { error: string }> {
  const id = ++scenes
  const { faces, error } = await command<{ faces: number; error?: string }>('open', { id, copies }, bytes)
  if (error) return { error }
  return {
    faces,
    call: (method, args = {}) => command(method, { ...args, id }),
    draw: async (method, args = {}) =>
      Uint8Array.from(atob(await command<string>(method, { ...args, id })), (letter) => letter.charCodeAt(0)),
    close: () => command('close', { id }),
  }
}
