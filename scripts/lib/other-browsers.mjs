import { accessSync, constants } from 'node:fs'
import { delimiter, join } from 'node:path'

const LIBRARIES = `/usr/lib/${process.arch === 'arm64' ? 'aarch64' : 'x86_64'}-linux-gnu`

/** WebKitGTK's own browser. */
export const MINI_BROWSER = `${LIBRARIES}/webkit2gtk-4.1/MiniBrowser`

/** Programs that each browser needs, with the Debian package that has each. */
const PROGRAMS = {
  firefox: { 'firefox-esr': 'firefox-esr', Xvfb: 'xvfb' },
  webkit: { WebKitWebDriver: 'webkit2gtk-driver', [MINI_BROWSER]: 'libwebkit2gtk-4.1-0', Xvfb: 'xvfb' },
}

/** Debian packages that must still be installed for tests in a browser: `firefox` or `webkit`. */
export function missingPackages(browser) {
  const missing = Object.entries(PROGRAMS[browser]).filter(([program]) => !isExecutable(program))
  return missing.map(([, name]) => name)
}

function isExecutable(program) {
  const folders = (process.env.PATH ?? '').split(delimiter)
  // A whole path has no use for the folders.
  return (program.startsWith('/') ? ['/'] : folders).some((folder) => {
    try {
      accessSync(join(folder, program), constants.X_OK)
      return true
    } catch {
      return false
    }
  })
}
