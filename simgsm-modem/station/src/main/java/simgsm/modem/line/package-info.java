/** The line of a real modem with its threads; the core that it serves knows neither. */
package simgsm.modem.line;
