import { accessSync, constants } from 'node:fs'
import { delimiter, join } from 'node:path'

const LIBRARIES = `/usr/lib/${process.arch === 'arm64' ? 'aarch64' : 'x86_64'}-linux-gnu`

/** Path of the browser that WebKitGTK includes. */
export const MINI_BROWSER = `${LIBRARIES}/webkit2gtk-4.1/MiniBrowser`

/** Programs that the tests in each browser need, with the Debian package of each program. */
export const PROGRAMS = {
  firefox: { 'firefox-esr': 'firefox-esr', Xvfb: 'xvfb' },
  webkit: { WebKitWebDriver: 'webkit2gtk-driver', [MINI_BROWSER]: 'libwebkit2gtk-4.1-0', Xvfb: 'xvfb' },
}

/** Returns the Debian packages that are missing for tests in `firefox` or `webkit`. */
export function missingPackages(browser) {
  const missing = Object.entries(PROGRAMS[browser]).filter(([program]) => !isExecutable(program))
  return missing.map(([, name]) => name)
}

function isExecutable(program) {
  const folders = (process.env.PATH ?? '').split(delimiter)
  return (program.startsWith('/') ? ['/'] : folders).some((folder) => {
    try {
      accessSync(join(folder, program), constants.X_OK)
      return true
    } catch {
      return false
    }
  })
}
