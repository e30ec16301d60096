import type { ChildProcess } from 'node:child_process'

/** A browser and the function that starts it. */
export interface BrowserKind {
  name: 'chromium' | 'firefox' | 'webkit'
  launch(start: Start): Promise<DrivenBrowser>
}

/** Starts programs on a virtual display and in a temporary folder. Both are created for one browser and removed when it closes. */
export interface Start {
  folder: string
  run(program: string, words: string[], env?: Record<string, string>): ChildProcess
}

/** Browser with one window, driven by WebDriver. */
export interface DrivenBrowser {
  version: string
  open(url: string): Promise<void>
  /**
   * Runs the body of an async function on the page.
   *
   * @returns its result, passed as JSON.
   */
  evaluate<T>(body: string): Promise<T>
  /** Performs WebDriver actions: real mouse and keyboard input. */
  act(actions: object[]): Promise<void>
  /** Takes a PNG screenshot of the page. */
  screenshot(): Promise<Buffer>
  resize(width: number, height: number): Promise<void>
  close(): Promise<void>
}

/** Time limit for starting a browser, milliseconds. */
const STARTING = 60_000

/** Waits until a program prints text that matches an expression. Returns the first capture group. */
export function outputOf(child: ChildProcess, stream: 'stdout' | 'stderr', text: RegExp): Promise<string> {
  return new Promise((resolve, reject) => {
    let output = ''
    const fail = (why: string) => reject(new Error(`${child.spawnfile}: ${why}: ${output.slice(-500)}`))
    const timer = setTimeout(() => fail(`no ${text} in its output`), STARTING)
    child.once('error', ({ message }) => fail(message))
    child.once('exit', () => fail('it has ended'))
    child[stream]!.on('data', (data) => {
      output += data
      const found = text.exec(output)
      if (!found) return
      clearTimeout(timer)
      resolve(found[1]!)
    })
  })
}
