package simrobot.app;

import java.net.InetAddress;
import java.net.UnknownHostException;
import simgsm.console.Arguments;
import simgsm.console.UsageException;

/** Where the program's ports listen. */
final class ListeningAddress {
    private ListeningAddress() {}

    /** As {@code --bind} says, else the loopback interface. */
    static InetAddress of(Arguments arguments) throws UsageException {
        return arguments.value("bind", ListeningAddress::read).orElse(InetAddress.getLoopbackAddress());
    }

    private static InetAddress read(String text) {
        try {
            return InetAddress.getByName(text);
        } catch (UnknownHostException e) {
            throw new IllegalArgumentException("expected an address of this machine, found " + text);
        }
    }
}
