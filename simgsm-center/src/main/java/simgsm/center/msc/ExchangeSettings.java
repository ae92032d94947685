package simgsm.center.msc;

import java.time.Instant;

/**
 * What an exchange is told at its start.
 *
 * @param networkName shown on the phones
 * @param seed of temporary identities
 * @param startedAt the civil time of the moment that the cores call 0 ns
 */
public record ExchangeSettings(String networkName, long seed, Instant startedAt) {
    public static final String DEFAULT_NETWORK_NAME = "SimGSM";
}
