/** Speech that arrives in bursts. */
package simgsm.gateway.speech;
