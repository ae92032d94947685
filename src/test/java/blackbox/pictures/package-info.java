/**
 * The documents' pictures, painted by the programs' own panels over a {@link blackbox.VirtualSuite}: without a display, and
 * the same at every run. {@code mvn -Ppictures -DskipTests package} renews them. Read first:
 * {@link blackbox.pictures.PicturesMain}.
 */
package blackbox.pictures;
