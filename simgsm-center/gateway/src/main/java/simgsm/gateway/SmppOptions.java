package simgsm.gateway;

import java.net.InetSocketAddress;
import simgsm.air.Msisdn;
import simgsm.console.Arguments;
import simgsm.console.HostPort;
import simgsm.console.UsageException;
import simgsm.gateway.esme.BindSettings;

/**
 * The SMSC of mail and fax.
 *
 * @param smsc its port of SMPP
 * @param systemId of the binds
 * @param password of the binds
 */
record SmppOptions(InetSocketAddress smsc, String systemId, String password) {
    private static final String DEFAULT_USER = "mail:";

    /** @param kind mail or fax, which needs these options */
    static SmppOptions of(Arguments arguments, String kind, String... needed) throws UsageException {
        for (String option : needed) {
            if (!arguments.has(option)) {
                throw new UsageException(
                        kind + " needs --" + String.join(", --", needed).replaceAll(", (?=[^,]*$)", " and ") + "; --"
                                + option + " is missing");
            }
        }
        String[] user = arguments
                .value("smpp-user", SmppOptions::user)
                .orElse(DEFAULT_USER)
                .split(":", 2);
        return new SmppOptions(address(arguments.hostPort("smpp").orElseThrow()), user[0], user[1]);
    }

    BindSettings bind(Msisdn number, String addressRange) {
        return new BindSettings(number, addressRange, systemId, password);
    }

    static InetSocketAddress address(HostPort at) {
        return InetSocketAddress.createUnresolved(at.host(), at.port());
    }

    private static String user(String text) {
        if (!text.matches("[!-9;-~]{1,15}:[!-~]{0,8}")) {
            throw new IllegalArgumentException(
                    "expected ID:PASSWORD with an ID of 1 to 15 and a password of at most 8 characters");
        }
        return text;
    }
}
