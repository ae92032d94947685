/**
 * Octets of messages and files: a bounds-checked reader, a writer, immutable strings of octets, and packed seven-bit
 * codes.
 */
package simgsm.octets;
