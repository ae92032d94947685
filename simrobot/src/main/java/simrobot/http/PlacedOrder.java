package simrobot.http;

import simgsm.web.WebResponse;

/**
 * The answer to a posted order.
 *
 * @param location path of the order; empty if it is invalid
 */
record PlacedOrder(WebResponse answer, String location) {}
