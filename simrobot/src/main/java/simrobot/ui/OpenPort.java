package simrobot.ui;

import java.util.Objects;

/**
 * A port on which others may come.
 *
 * @param protocol as people call it: P2OS, HTTP, AT
 * @param robot whose port it is; empty when it is the whole program's
 */
public record OpenPort(String protocol, String robot, int port) {
    public OpenPort {
        Objects.requireNonNull(protocol);
        Objects.requireNonNull(robot);
    }
}
