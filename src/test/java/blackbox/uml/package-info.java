/**
 * Prints the diagrams of {@code docs/uml} from the code and from runs, and compares them with the files there.
 * {@code mvn -o -pl src/test -am -Dtest='blackbox.uml.*Test,*ReferenceTest' -Dsurefire.failIfNoSpecifiedTests=false -Duml.write=true package}
 * writes them anew; {@code mvn -N -Puml exec:java} then draws the SVG files.
 */
package blackbox.uml;
