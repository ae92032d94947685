/** Texts as fax pages: 1728 pixels wide, in the code of T.4 one-dimensional, as files of TIFF-F. */
package simgsm.gateway.fax;
