package simgsm.gateway.mail;

import simgsm.air.Msisdn;

/**
 * The settings of mail.
 *
 * @param number the application's own: a message to it becomes mail
 * @param domain of the addresses NUMBER@domain
 * @param systemId of the bind
 * @param password of the bind
 * @param mails false without a mail server for messages from phones
 */
public record MailSettings(Msisdn number, String domain, String systemId, String password, boolean mails) {}
