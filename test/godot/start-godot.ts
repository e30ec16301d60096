export type Json = Record<string, unknown>

/** Properties of Godot's class `Engine` that this module uses. */
export interface GodotEngine {
  startGame(override: object): Promise<void>
  requestQuit(): void
}

declare global {
  interface Window {
    Engine: new (config: object) => GodotEngine
    godotReady(): void
    godotCommand(id: number, name: string, args: string, bytes: ArrayBuffer | null): void
    godotResult(id: number, result: string): void
  }
}

/**
 * Starts Godot with the project in `project`.
 *
 * @param onMessage receives errors and warnings of the engine.
 */
export async function startGodot(onMessage: (text: string) => void): Promise<GodotEngine> {
  const script = document.createElement('script')
  script.src = '/godot/index.js'
  const loaded = new Promise((done) => script.addEventListener('load', done))
  document.head.append(script)
  await loaded
  const canvas = document.body.appendChild(document.createElement('canvas'))
  // The engine finds the canvas by its id.
  canvas.id = 'godot'
  canvas.width = canvas.height = 64
  const ready = new Promise<void>((done) => {
    window.godotReady = done
  })
  const engine = new window.Engine({
    executable: '/godot/index',
    mainPack: '/godot/project.pck',
    canvas,
    canvasResizePolicy: 0,
    onPrint: (...texts: string[]) => console.info(...texts),
    onPrintError: (...texts: string[]) => onMessage(texts.join(' ')),
  })
  await engine.startGame({})
  await ready
  return engine
}

let calls = 0
const pending = new Map<number, (result: unknown) => void>()

/** Runs a command of `project/main.gd`, and returns its result. */
export function command<T>(name: string, args: Json, bytes: ArrayBuffer | null = null): Promise<T> {
  window.godotResult = (id, result) => {
    pending.get(id)!(JSON.parse(result))
    pending.delete(id)
  }
  const id = ++calls
  return new Promise((done) => {
    pending.set(id, done as (result: unknown) => void)
    window.godotCommand(id, name, JSON.stringify(args), bytes)
  })
}
