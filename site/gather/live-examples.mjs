// Bundles the examples from the built packages, because the site's server does not have the files that their import maps name.

import { join } from 'node:path'
import { build } from 'vite'
import { exampleNames } from '../../scripts/lib/examples.mjs'
import { ROOT } from '../../scripts/lib/run.mjs'

/** Folder of the faces, relative to a running example. The studio's build contains them. */
const FACES = '../../studio/faces/'

/** Writes `NAME.html` for every example. */
export function buildLiveExamples(outDir) {
  const root = join(ROOT, 'examples')
  return build({
    configFile: false,
    root,
    base: './',
    logLevel: 'error',
    plugins: [forStatic()],
    worker: { format: 'es' },
    build: {
      outDir,
      emptyOutDir: true,
      chunkSizeWarningLimit: 2500,
      rolldownOptions: { input: exampleNames().map((name) => join(root, `${name}.html`)) },
    },
  })
}

/** Removes import maps, which a bundled page does not need, and makes URLs relative, so that the site works under any path. */
function forStatic() {
  return {
    name: 'furrow-static-examples',
    enforce: 'pre',
    transformIndexHtml: {
      order: 'pre',
      handler: (html) => relativeFaces(html.replace(/<script type="importmap">[\s\S]*?<\/script>\n?/, '')),
    },
    // An inline script is a virtual module, whose relative imports are resolved against the examples folder.
    resolveId(source, importer) {
      if (!source.startsWith('./') || !importer?.includes('html-proxy')) return null
      return join(ROOT, 'examples', source)
    },
    transform: (code) => (code.includes('/faces/') ? relativeFaces(code) : null),
  }
}

function relativeFaces(text) {
  return text.replace(/(['"`])\/faces\//g, `$1${FACES}`)
}
