/**
 * What users install, made by {@code mvn -Pimage -DskipTests package}: a runtime image with the suite's modules, launchers,
 * icons, archives and a Debian package. Read first: {@link blackbox.image.ImageMain}.
 */
package blackbox.image;
