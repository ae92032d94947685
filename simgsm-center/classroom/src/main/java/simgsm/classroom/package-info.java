/**
 * The centre's command line with the options that start other programs. Arrows: classroom -&gt; lesson -&gt; demo -&gt;
 * ui.
 */
package simgsm.classroom;
