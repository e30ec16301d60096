import { keepPage } from './offline/keep-page.ts'
import { findPage } from './page.ts'
import { Studio } from './studio.ts'

void new Studio(findPage()).start()
keepPage()
