package simgsm.gateway.mail;

import simgsm.air.Msisdn;
import simgsm.console.TextBundle;
import simgsm.gateway.esme.BindSettings;

/**
 * The settings of mail.
 *
 * @param bind of the application: a message to its number becomes mail
 * @param domain of the addresses NUMBER@domain
 * @param mails false without a mail server for messages from phones
 * @param words of the notices to phones
 */
public record MailSettings(BindSettings bind, String domain, boolean mails, TextBundle words) {
    /** Digits of the application's number; the numbers of mails begin with it. */
    public static final int MOST_DIGITS = Msisdn.MAX_DIGITS - Correspondences.LEAST_DIGITS;
}
