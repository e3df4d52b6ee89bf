// The page with the engine inside: what one_file.mjs puts into the file.
import './local.js';
import '../page/main.js';
