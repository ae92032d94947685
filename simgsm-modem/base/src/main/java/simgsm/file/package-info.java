/** Files: reading text, errors that name the file, and writing in one step. */
package simgsm.file;
