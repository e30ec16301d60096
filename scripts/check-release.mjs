// `node scripts/check-release.mjs v0.1.0`: checks that the versions of the packages and the changelog match a release
// tag.

import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { Failure, main, ROOT, say } from './lib/run.mjs'

const PACKAGES = ['packages/furrow', 'packages/cli']

await main(async () => {
  const [tag = ''] = process.argv.slice(2)
  const [, version] = /^v(\d+\.\d+\.\d+(?:-[\w.]+)?)$/.exec(tag) ?? []
  if (!version)
    throw new Failure(`invalid tag, got "${tag}", allowed: v and a semantic version; write e.g. v0.1.0`)
  for (const folder of PACKAGES) {
    const found = JSON.parse(readFileSync(join(ROOT, folder, 'package.json'), 'utf8')).version
    if (found === version) continue
    throw new Failure(`${folder} has version ${found}, allowed: ${version}; change it or the tag`)
  }
  const changelog = readFileSync(join(ROOT, 'CHANGELOG.md'), 'utf8')
  const isNamed = changelog.split('\n').some((line) => line.startsWith('## ') && line.includes(version))
  if (!isNamed) throw new Failure(`CHANGELOG.md has no section for ${version}; write one`)
  say(`${version} can be released`)
})
