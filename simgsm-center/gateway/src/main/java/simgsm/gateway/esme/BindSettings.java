package simgsm.gateway.esme;

import simgsm.air.Msisdn;

/**
 * What an application tells the SMSC about itself.
 *
 * @param number its own: the address_range of the bind
 * @param systemId 1 to 15 characters
 * @param password at most 8 characters
 */
public record BindSettings(Msisdn number, String systemId, String password) {}
