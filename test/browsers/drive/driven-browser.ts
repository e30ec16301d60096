import type { ChildProcess } from 'node:child_process'

/** A way to start a browser. */
export interface BrowserKind {
  name: 'chromium' | 'firefox' | 'webkit'
  launch(start: Start): Promise<DrivenBrowser>
}

/** Starts a program on the display of a browser, with a folder of its own; both end with the browser. */
export interface Start {
  folder: string
  run(program: string, words: string[], env?: Record<string, string>): ChildProcess
}

/** A browser with one window, driven by WebDriver. */
export interface DrivenBrowser {
  version: string
  open(url: string): Promise<void>
  /**
   * Runs the body of an async function on the page.
   *
   * @returns its result, which is sent as JSON.
   */
  evaluate<T>(body: string): Promise<T>
  /** Performs actions of WebDriver: real input of mouse and keyboard. */
  act(actions: object[]): Promise<void>
  /** Picture of the page, as PNG. */
  screenshot(): Promise<Buffer>
  resize(width: number, height: number): Promise<void>
  close(): Promise<void>
}

/** Milliseconds that a browser may take to start. */
const STARTING = 60_000

/** Waits for a text in the output of a program; its first group. */
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
