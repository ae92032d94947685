/** The ciphering of the air interface (TS 43.020, annex C): keys, A5/1 and A5/3. Read {@link simgsm.cells.cipher.CipherKey}. */
package simgsm.cells.cipher;
