package simgsm.web;

import java.util.function.Function;

/**
 * A path for WebSockets.
 *
 * @param protocol named in the answer if the client offers it; empty for none
 * @param admitsEveryOrigin true if pages of other hosts may open it, otherwise refused with 403
 * @param mostOctets of a message from the client
 * @param listeners makes the receiver of a new socket
 */
public record WebSocketPath(
        String path,
        String protocol,
        boolean admitsEveryOrigin,
        int mostOctets,
        Function<WebSocket, WebSocketListener> listeners) {}
