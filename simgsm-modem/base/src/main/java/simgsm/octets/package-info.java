/**
 * Octets of messages and files: a reader that refuses to read past the end, a writer, immutable strings of octets, and
 * packed seven-bit codes.
 */
package simgsm.octets;
