package simgsm.web;

import java.util.function.Function;

/**
 * A path of a port that takes WebSockets.
 *
 * @param protocol named in the answer if the client offers it; empty for none
 * @param admitsEveryOrigin whether pages of other hosts may open it; else they are refused with 403
 * @param mostOctets of a message from the client
 * @param listeners makes the receiver of a new socket
 */
public record WebSocketPath(
        String path,
        String protocol,
        boolean admitsEveryOrigin,
        int mostOctets,
        Function<WebSocket, WebSocketListener> listeners) {}
