package simgsm.gateway.esme;

import simgsm.air.Msisdn;

/**
 * What an application tells the SMSC about itself.
 *
 * @param number its own
 * @param addressRange of the bind: the number, or {@code ^} and the beginning of several
 * @param systemId 1 to 15 characters
 * @param password at most 8 characters
 */
public record BindSettings(Msisdn number, String addressRange, String systemId, String password) {}
