/**
 * The interpreter of AT commands (ITU-T V.250), independent of their meaning: command lines, prompts, result codes
 * and unsolicited codes of one client, and the table of commands, which prints itself.
 *
 * <p>Read first: {@link simgsm.modem.at.AtSession}, then {@link simgsm.modem.at.AtCommandTable}.
 */
package simgsm.modem.at;
